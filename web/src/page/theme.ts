// The colors of the site, which the system or the visitor changes.

/** Returns a function that gives the present value of a custom property. */
export function colorsOf(element: Element): (name: string) => string {
  const style = getComputedStyle(element);
  return (name) => style.getPropertyValue(name).trim();
}

/** Calls when the colors of the page have changed. Returns a function that ends it. */
export function onThemeChange(call: () => void): () => void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const chosen = new MutationObserver(call);
  chosen.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  system.addEventListener("change", call);
  return () => {
    chosen.disconnect();
    system.removeEventListener("change", call);
  };
}
