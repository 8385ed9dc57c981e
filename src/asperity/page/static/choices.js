// Choices: materials of the bodies, variants of the model, what holds the ring, and a finish of the library.

import { label } from "/controls.js";
import { element, number } from "/numbers.js";

const plain = (word) => word.replaceAll("_", " ");

/** Rows with a list of words for the choices of one section of the joint file. */
export function choiceRows(controls, group, stated) {
  const library = controls.description.materials.map((each) => each.name);
  const own = Object.keys(stated.numbers).filter((path) => path.startsWith("materials.")).map((path) => path.split(".")[1]);
  return controls.description.choices
    .filter((choice) => choice.group === group)
    .map((choice) => {
      const id = `value-${choice.key.replaceAll(".", "-")}`;
      const words = choice.words.length ? choice.words : [...new Set([...own, ...library])];
      const options = words.map((word) => element("option", { value: word }, plain(word)));
      if (!choice.required) {
        const otherwise = choice.default && choice.default !== "if absent" ? choice.default : "not in the file";
        options.unshift(element("option", { value: "" }, otherwise));
      }
      const select = element("select", { id, "aria-describedby": `${id}-help ${id}-error` }, ...options);
      const error = element("p", { class: "field-error", id: `${id}-error` });
      const help = element("p", { class: "help", id: `${id}-help` }, choice.meaning);
      const row = { path: choice.key, input: select, error, choice, help, materials: choice.words.length ? [] : controls.description.materials };
      select.addEventListener("change", () => controls.changed(choice.key, select.value));
      controls.rows.set(choice.key, row);
      return element("div", { class: "row choice", "data-path": choice.key }, element("label", { for: id }, label(choice.key)), select, help, error);
    });
}

/** The word of an answer, and for a material of the library what it is and where its numbers come from. */
export function showChoice(row, stated, changes) {
  const word = changes[row.path] ?? stated.choices[row.path] ?? "";
  row.input.value = word;
  const material = row.materials.find((each) => each.name === word);
  const more = material ? ` ${word}: ${material.description}. Source: ${material.reference}.` : "";
  const text = `${row.choice.meaning}${more}`;
  if (row.help.textContent !== text) row.help.textContent = text;
}

/** A list of the finishes of the library, which sets D, G and gamma of all contacts in one step. */
export function finishRow(controls) {
  const id = "value-finish";
  const ends = controls.description.finishes.flatMap((finish) =>
    ["finest", "coarsest"].map((name, i) => ({
      name: `${finish.name} ${name}`,
      text: `${finish.name}, ${name}: Ra ${number(finish.roughness_average_um[i])} µm`,
      finish,
      values: {
        "surface.fractal_dimension": finish.fractal_dimension[i],
        "surface.fractal_roughness": `${number(finish.fractal_roughness_mm[i], 6)} mm`,
        "surface.frequency_ratio": finish.frequency_ratio,
      },
    })),
  );
  const select = element(
    "select",
    { id, "aria-describedby": `${id}-help` },
    element("option", { value: "" }, "other values"),
    ...ends.map((end) => element("option", { value: end.name }, end.text)),
  );
  const meaning =
    "Sets D, G and gamma of all contacts to an end of the range that is published for a process; it is taken as the roughness of both bodies together.";
  const help = element("p", { class: "help", id: `${id}-help` }, meaning);
  select.addEventListener("change", () => {
    const end = ends.find((each) => each.name === select.value);
    if (end) controls.together(end.values, ["surface"]);
  });
  controls.finish = {
    show(stated) {
      const same = (path, value) => path in stated.numbers && Math.abs(stated.numbers[path].value / parseFloat(value) - 1) < 1e-4;
      const found = ends.find((end) => Object.entries(end.values).every(([path, value]) => same(path, value)));
      select.value = found ? found.name : "";
      const text = found ? `${meaning} ${found.finish.name}: ${found.finish.description}. Source: ${found.finish.reference}.` : meaning;
      if (help.textContent !== text) help.textContent = text;
    },
  };
  return element("div", { class: "row choice" }, element("label", { for: id }, "finish of the library"), select, help);
}
