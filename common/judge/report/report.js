"use strict";
const all = (selector, within = document) => [...within.querySelectorAll(selector)];
const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

// Opens everything around the case that the address points to.
function reveal() {
  let place = null;
  try { place = document.getElementById(decodeURIComponent(location.hash.slice(1))); } catch { /* no valid address */ }
  if (!place) return;
  for (let part = place; part; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
  place.scrollIntoView();
}
addEventListener("hashchange", reveal);
addEventListener("click", event => { if (event.target.closest("a[href^='#']")) setTimeout(reveal); });
reveal();

// Paper cannot be unfolded.
let folded = [];
addEventListener("beforeprint", () => {
  folded = all("details:not([open])");
  folded.forEach(part => { part.open = true; });
});
addEventListener("afterprint", () => folded.forEach(part => { part.open = false; }));

// Copying needs a secure context; if the browser refuses, select the command instead.
for (const code of all("code.command")) {
  const button = make("button", {type: "button", textContent: "copy"});
  button.addEventListener("click", async () => {
    try { await navigator.clipboard.writeText(code.textContent); button.textContent = "copied"; }
    catch { getSelection().selectAllChildren(code); button.textContent = "selected"; }
  });
  code.after(" ", button);
}

// Yours on the left of the line, the reference on the right; reuses the page's pictures. The range input on top makes
// it work with a pointer, a finger, the keyboard and a screen reader.
for (const pictures of all(".pictures")) {
  const [yours, reference, difference] =
    ["yours", "reference", "difference"].map(role => pictures.querySelector(`[data-role=${role}]`));
  if (!difference) continue;
  const range = make("input", {type: "range", min: 0, max: 100, step: 1, value: 50});
  range.setAttribute("aria-label", "Wipe between your picture and the reference");
  const copies = [yours, reference].map(figure => figure.querySelector("img").cloneNode());
  copies.forEach(copy => { copy.alt = ""; });
  const box = make("div", {className: "compare"}, ...copies, range);
  const wipe = () => {
    box.style.setProperty("--cut", range.value + "%");
    range.setAttribute("aria-valuetext", `${Math.round(range.value)} % yours, the rest reference`);
  };
  range.addEventListener("input", wipe);
  wipe();
  const figure = make("figure", {className: "slider"}, box,
                      make("figcaption", {textContent: "Wipe: yours | reference"}));
  difference.after(figure);
}

// One picture at full size; the arrow keys replace it in the same place, so that differences seem to move.
const image = make("img"), caption = make("span");
const viewer = make("dialog", {}, make("figure", {}, image, make("figcaption", {}, caption,
  make("span", {className: "soft", textContent: " \u2190 \u2192 to change, Esc to close"}))));
viewer.setAttribute("aria-label", "Picture at full size");
document.body.append(viewer);
let shown = [], at = 0;
function show(index) {
  at = (index + shown.length) % shown.length;
  const source = shown[at], first = shown[0];
  const fit = Math.min(innerWidth * .96 / first.naturalWidth, (innerHeight - 90) / first.naturalHeight);
  const width = first.naturalWidth * (fit >= 1 ? Math.floor(fit) : fit);
  image.src = source.src;
  image.alt = source.alt;
  image.style.width = Math.min(width, width * source.naturalWidth / source.naturalHeight
                                      * first.naturalHeight / first.naturalWidth) + "px";
  caption.textContent = source.closest("figure").querySelector("figcaption").textContent;
}
for (const button of all(".pictures button")) {
  button.addEventListener("click", () => {
    shown = all(".pictures button img", button.closest("details, .card"));
    show(shown.indexOf(button.querySelector("img")));
    viewer.showModal();
  });
}
viewer.addEventListener("click", () => viewer.close());
viewer.addEventListener("keydown", event => {
  const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
  if (step) { event.preventDefault(); show(at + step); }
});
