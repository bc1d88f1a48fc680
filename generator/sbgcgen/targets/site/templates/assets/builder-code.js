// The lines of code that make a message of values, in the types of each language. What has no type here is
// assigned as text, as `sbgc send` reads it. `facts` are those of builder.py.
"use strict";

const sbgcBuilderCode = (name, { family, facts, enums }) => {
  const languages = {
    cpp: {
      enumerator: (type, value) =>
        enums[type].names[value] ? `sbgc::msg::${type}::${enums[type].names[value][1]}` : `static_cast<sbgc::msg::${type}>(${value})`,
      flag: (type, value) => `sbgc::msg::${enums[type].member}::${enums[type].names[value][1]}`,
      number: (text) => (Number(text) > 0x7fffffff ? `${text}U` : text),
      quantity: (text, unit) => `${text}_${unit}`,
      yes: "true",
    },
    python: {
      enumerator: (type, value) => (enums[type].names[value] ? `msg.${type}.${enums[type].names[value][0]}` : `msg.${type}(${value})`),
      flag: (type, value) => `msg.${type}.${enums[type].names[value][0]}`,
      number: (text) => text,
      quantity: (text) => text,
      yes: "True",
    },
  };

  let all = ""; // the texts of all lines, which may have the flag that selects another unit

  /** The expression for a text; null if there is none. */
  function expression(fact, text, words) {
    if (!fact || fact.special?.includes(text) || (fact.unless && all.includes(fact.unless))) return null;
    const isInteger = /^-?\d+$/.test(text);
    if (fact.unit) return /^-?\d+(\.\d+)?$/.test(text) ? words.quantity(text, fact.unit) : null;
    if (fact.number) return isInteger ? words.number(text) : null;
    if (fact.bool) return text === "1" ? words.yes : null;
    if (fact.enum) return isInteger || enums[fact.enum].names[text] ? words.enumerator(fact.enum, text) : null;
    const flags = text.split("|");
    return fact.flags && flags.every((one) => enums[fact.flags].names[one])
      ? flags.map((one) => words.flag(fact.flags, one)).join(" | ")
      : null;
  }

  /** The parts of a packed value, "MODE_ANGLE,flags:A|B", as [name, expression]; null if one has none. */
  function partsOf(fact, text, words) {
    const found = text.split(",").map((one) => {
      const [, given, value] = /^(?:(\w+):)?(.*)$/.exec(one);
      const first = value.split("|")[0];
      const part = given ?? fact.order.find((part) => enums[fact.parts[part].enum ?? fact.parts[part].flags]?.names[first]);
      return [part, expression(fact.parts[part], value, words)];
    });
    return found.every(([, made]) => made !== null) ? found : null;
  }

  const asCpp = (path, text) => {
    const fact = facts[path];
    if (fact?.packed) {
      return partsOf(fact, text, languages.cpp)?.map(([part, made]) => `message.${path}.set_${part}(${made});`).join("\n") ?? null;
    }
    if (fact?.each) {
      const each = text.split(",").map((one) => expression(fact.each, one, languages.cpp));
      return each.includes(null) ? null : each.map((one, i) => `message.${path}[${i}] = ${one};`).join("\n");
    }
    const made = expression(fact, text, languages.cpp);
    return made === null ? null : `message.${path} = ${made};`;
  };

  const asPython = (path, text) => {
    const fact = facts[path];
    if (fact?.each) {
      const each = text.split(",").map((one) => expression(fact.each, one, languages.python));
      return each.includes(null) ? null : `[${each.join(", ")}]`;
    }
    if (!fact?.packed) return expression(fact, text, languages.python);
    const parts = partsOf(fact, text, languages.python);
    return parts && `msg.${fact.packed}(${parts.map(([part, made]) => `${part}=${made}`).join(", ")})`;
  };

  const makeFrame = (encoded) => ["std::array<std::uint8_t, sbgc::max_frame_size> frame{};", `const sbgc::WriteResult written = ${encoded};`];

  const remember = (lines) => (all = lines.map(([, text]) => text).join(" "));

  function cpp(lines) {
    remember(lines);
    const made = lines.map(([path, text]) => asCpp(path, text));
    if (made.includes(null)) {
      return [
        "#include <array>\n#include <cstdint>\n\n#include <sbgc/any.hpp>\n",
        `sbgc::AnyMessage message = sbgc::find_message("${name}")->make();`,
        ...lines.map(([path, text]) => `message.assign(${JSON.stringify(path)}, ${JSON.stringify(text)});`),
        ...makeFrame("message.encode_frame(sbgc::basic_framing, frame)"),
      ].join("\n");
    }
    const literals = made.some((line) => /\d_[A-Za-z]/.test(line)) ? ["using namespace sbgc::literals;\n"] : [];
    return [
      `#include <array>\n#include <cstdint>\n\n#include <sbgc/message.hpp>\n#include <sbgc/messages/${family}.hpp>\n`,
      ...literals,
      `sbgc::msg::${name} message;`,
      ...made,
      ...makeFrame("sbgc::encode_frame(message, frame)"),
    ].join("\n");
  }

  /** A call with keywords, on one line or with a line for each. */
  function call(head, tree, path, indent) {
    const margin = " ".repeat(indent + 4);
    const parts = [...tree].map(([step, value]) => {
      const inner = path ? `${path}.${step}` : step;
      const word = `${facts[inner]?.attribute ?? step}=`;
      return word + (value instanceof Map ? call(`msg.${facts[inner].class}`, value, inner, indent + 4) : value);
    });
    const line = `${head}(${parts.join(", ")})`;
    if (!line.includes("\n") && indent + line.length < 80) return line;
    return `${head}(\n${parts.map((part) => `${margin}${part},\n`).join("")}${" ".repeat(indent)})`;
  }

  function python(lines) {
    remember(lines);
    const tree = new Map();
    const later = [];
    for (const [path, text] of lines) {
      const made = asPython(path, text);
      if (made === null) {
        later.push(`message.assign(${JSON.stringify(path)}, ${JSON.stringify(text)})`);
        continue;
      }
      const steps = path.split(".");
      let place = tree;
      for (const step of steps.slice(0, -1)) place = place.get(step) ?? place.set(step, new Map()).get(step);
      place.set(steps.at(-1), made);
    }
    const message = call(`msg.${name}`, tree, "", 0);
    return ["from sbgc import encode, msg\n", `message = ${message}`, ...later, "frame = encode(message)"].join("\n");
  }

  return { cpp, python };
};
