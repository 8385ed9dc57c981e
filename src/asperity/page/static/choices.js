// Choices: materials of the bodies, variants of the model, what holds the ring, and a finish of the library.

import { label } from "/controls.js";
import { element, number } from "/numbers.js";

const plain = (word) => word.replaceAll("_", " ");

/** Rows with a list of words for the choices of one section of the joint file. */
export function choiceRows(controls, group, stated) {
  const library = controls.description.materials.map((each) => each.name);
  const own = Object.keys(stated.numbers).filter((path) => path.startsWith("materials.")).map((path) => path.split(".")[1]);
  return controls.description.choices
    .filter((choice) => choice.group === group && choice.key !== FINISH) // which has a list of its own
    .map((choice) => {
      const id = `value-${choice.key.replaceAll(".", "-")}`;
      const words = choice.words.length ? choice.words : [...new Set([...own, ...library])];
      const options = words.map((word) => element("option", { value: word }, plain(word)));
      if (!choice.required) {
        options.unshift(element("option", { value: "" }, choice.default || "not in the file"));
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

const FINISH = "surface.finish";

/** What a finish sets where Ra or Rz is that of the drawing: the file's, or the middle of the published range. */
function ofDrawing(finish, stated) {
  const own = stated.numbers["surface.roughness_average"];
  const depth = stated.entered["surface.mean_roughness_depth"];
  const [low, high] = finish.roughness_average_um;
  const process = { [FINISH]: finish.name, "surface.fractal_dimension": "", "surface.frequency_ratio": "" };
  if (depth) return { ...process, "surface.mean_roughness_depth": depth.text };
  return {
    ...process,
    "surface.roughness_average": own ? `${number(own.value, 6)} um` : `${number(Math.sqrt(low * high), 2)} um`,
  };
}

/** A list of the finishes of the library: with the Ra of the drawing, or D, G and gamma at an end of the published range. */
export function finishRow(controls, stated) {
  const id = "value-finish";
  const { finishes } = controls.description;
  const ends = finishes.flatMap((finish) =>
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
  const options = (entries) => entries.map(({ name, text }) => element("option", { value: name }, text));
  const select = element(
    "select",
    { id, "aria-describedby": `${id}-help` },
    element("option", { value: "" }, "other values"),
    element("optgroup", { label: "Ra of the drawing, D of the process" }, ...options(finishes.map((each) => ({ name: each.name, text: each.name })))),
    element("optgroup", { label: "D and G at an end of the published range" }, ...options(ends)),
  );
  const meaning =
    "The upper entries take the Ra of the drawing and the range of D that is published for the process: the stiffness is that of its middle, with its interval below. " +
    "The lower ones set D, G and gamma of all contacts to an end of the published range, taken as the roughness of both bodies together.";
  const help = element("p", { class: "help", id: `${id}-help` }, meaning);
  let now = stated;
  select.addEventListener("change", () => {
    const end = ends.find((each) => each.name === select.value);
    const finish = finishes.find((each) => each.name === select.value);
    if (end) controls.together(now.choices[FINISH] ? { [FINISH]: "", ...end.values } : end.values, ["surface"]);
    else if (finish) controls.together(ofDrawing(finish, now), ["surface"]);
  });
  controls.finish = {
    show(answer) {
      now = answer;
      const same = (path, value) => path in now.numbers && Math.abs(now.numbers[path].value / parseFloat(value) - 1) < 1e-4;
      const named = "surface.roughness_average" in now.numbers && finishes.find((each) => each.name === now.choices[FINISH]);
      const end = ends.find((each) => Object.entries(each.values).every(([path, value]) => same(path, value)));
      const found = named || (end && end.finish);
      select.value = named ? named.name : end ? end.name : "";
      const text = found ? `${meaning} ${found.name}: ${found.description}. Source: ${found.reference}.` : meaning;
      if (help.textContent !== text) help.textContent = text;
    },
  };
  return element("div", { class: "row choice" }, element("label", { for: id }, "finish of the library"), select, help);
}
