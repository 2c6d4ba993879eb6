"use strict";
const all = (selector, within = document) => [...within.querySelectorAll(selector)];

// Opens the case that a link from the table or the terminal points to.
function reveal() {
  const place = document.getElementById(decodeURIComponent(location.hash.slice(1)))?.closest("details");
  if (place) { place.open = true; place.scrollIntoView(); }
}
addEventListener("hashchange", reveal);
reveal();

// Open all cases for printing.
addEventListener("beforeprint", () => all("details").forEach(d => { d.open = true; }));

const filter = document.getElementById("filter");
filter.hidden = false;
filter.addEventListener("click", () => {
  const on = document.body.classList.toggle("filtered");
  filter.setAttribute("aria-pressed", String(on));
});

// Copying needs a secure context; if the browser refuses, select the command instead.
for (const code of all("code.command")) {
  const button = document.createElement("button");
  button.textContent = "copy";
  button.addEventListener("click", async () => {
    try { await navigator.clipboard.writeText(code.textContent); button.textContent = "copied"; }
    catch { getSelection().selectAllChildren(code); button.textContent = "selected"; }
  });
  code.after(button);
}

// Reference on the left of the line, yours on the right; reuses the page's pictures.
for (const pictures of all(".pictures")) {
  const [reference, yours] = ["reference", "yours"].map(role => pictures.querySelector(`[data-role=${role}] img`));
  if (!reference || !yours || !pictures.querySelector("[data-role=difference]")) continue;
  const figure = document.createElement("figure");
  figure.className = "slider";
  const box = document.createElement("div");
  box.className = "compare";
  const range = document.createElement("input");
  Object.assign(range, {type: "range", min: 0, max: 100, step: 0.5, value: 50});
  range.setAttribute("aria-label", "How much of the reference to show");
  range.addEventListener("input", () => box.style.setProperty("--cut", range.value + "%"));
  const copies = [reference, yours].map(image => image.cloneNode());
  copies.forEach(copy => { copy.alt = ""; });
  const caption = document.createElement("figcaption");
  caption.textContent = "Slide: reference | yours";
  box.append(...copies, range);
  figure.append(box, caption);
  pictures.querySelector("[data-role=difference]").after(figure);
}

// One picture at full size; the arrow keys replace it in the same place, so that differences seem to move.
const viewer = document.getElementById("viewer");
let shown = [], at = 0;
function show(index) {
  at = (index + shown.length) % shown.length;
  const source = shown[at], first = shown[0];
  const fit = Math.min(innerWidth * .96 / first.naturalWidth, (innerHeight - 90) / first.naturalHeight);
  const width = first.naturalWidth * (fit >= 1 ? Math.floor(fit) : fit);
  const image = viewer.querySelector("img");
  image.src = source.src;
  image.alt = source.alt;
  image.style.width = Math.min(width, width * source.naturalWidth / source.naturalHeight
                                      * first.naturalHeight / first.naturalWidth) + "px";
  viewer.querySelector(".caption").textContent = source.dataset.title;
}
for (const button of all(".pictures button")) {
  button.addEventListener("click", () => {
    shown = all("button img", button.closest(".pictures"));
    show(shown.indexOf(button.querySelector("img")));
    viewer.showModal();
  });
}
viewer.addEventListener("click", () => viewer.close());
viewer.addEventListener("keydown", event => {
  const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
  if (step) { event.preventDefault(); show(at + step); }
});
