// Files of the vendor's program, which are XML. Only a page has a parser for it, not its worker.

/** Returns the elements of a file as lines, for web/modules/setup.cpp: <NAME, =TEXT and >. */
export function elementsOf(xml: string): string {
  if (/<!DOCTYPE/i.test(xml)) throw new Error("a document type is not allowed");
  const parsed = new DOMParser().parseFromString(xml, "text/xml");
  if (parsed.querySelector("parsererror")) throw new Error("this is neither a backup nor XML");
  const lines: string[] = [];
  const walk = (element: Element): void => {
    lines.push(`<${element.tagName}`);
    for (const node of element.childNodes) {
      if (node instanceof Element) walk(node);
      else if (node instanceof CharacterData) lines.push(`=${node.data.replaceAll("\n", " ")}`);
    }
    lines.push(">");
  };
  walk(parsed.documentElement);
  return `${lines.join("\n")}\n`;
}
