// The help of the row that has the focus. It waits while a pointer is down: what a click is meant for must not move away.

/** Mark the row with the focus by a class; the style of the page shows its help. */
export function showHelp(form) {
  let held = false;
  const show = () => {
    if (held) return;
    const row = form.contains(document.activeElement) ? document.activeElement.closest(".row") : null;
    for (const other of form.querySelectorAll(".row.in-use")) if (other !== row) other.classList.remove("in-use");
    if (row) row.classList.add("in-use");
  };
  const hold = (event) => {
    if (event.button === 0) held = true;
  };
  const release = () => {
    held = false;
    show();
  };
  const releaseAfterClick = () => setTimeout(release, 0); // a click follows the release of the pointer in the same task
  // a touch gives its mouse events, and with them the focus, after the pointer has left
  for (const type of ["pointerdown", "mousedown"]) document.addEventListener(type, hold, true);
  for (const type of ["pointerup", "pointercancel", "mouseup", "dragend"]) document.addEventListener(type, releaseAfterClick, true);
  // the list of a select may keep the end of the press to itself
  document.addEventListener("change", (event) => event.target instanceof HTMLSelectElement && release(), true);
  document.addEventListener("keydown", release, true);
  for (const type of ["focusin", "focusout"]) form.addEventListener(type, show);
}
