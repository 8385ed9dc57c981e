// What the page says: to those who listen, and for a while to those who look.

const SAID = 10000; // ms that a message stays in view

const get = (id) => document.getElementById(id);
let later = 0; // the timer of SAID

/** A message; `quiet` where those who look see it elsewhere. */
export function say(text, quiet = false) {
  const status = get("status");
  if (status.textContent !== text) status.textContent = text;
  status.classList.toggle("quiet", quiet);
  clearTimeout(later);
  if (!quiet) later = setTimeout(() => status.classList.add("quiet"), SAID);
}

/** What is wrong with the server; nothing if it answers. */
export function banner(text) {
  get("banner").hidden = !text;
  get("banner").textContent = text;
}

/** A message that is not about the values: the results stay as they are. */
export function notice(text) {
  get("error").hidden = false;
  get("error").textContent = text;
}
