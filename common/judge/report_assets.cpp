#include "judge/report_assets.hpp"

namespace atelier::judge {

const std::string_view report_css = R"css(
:root {
  color-scheme: light dark;
  --page: #f7f6f3; --card: #ffffff; --ink: #22262b; --soft: #646b74; --line: #e3e1db; --tint: #f1efea;
  --passed: #2f7d54; --failed: #b23b32; --missing: #946a11; --broken: #7b4b9e; --accent: #2d6187;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #16181b; --card: #1e2125; --ink: #e2e4e7; --soft: #9aa2ab; --line: #31363c; --tint: #272b30;
    --passed: #6fc494; --failed: #ec8379; --missing: #dcb45c; --broken: #c29be0; --accent: #86b8dd;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); font: 16px/1.55 system-ui, sans-serif; }
main, header.top { max-width: 72rem; margin: 0 auto; padding: 0 1.5rem; }
header.top { padding-top: 2.5rem; display: flex; flex-wrap: wrap; align-items: baseline; gap: .25rem 1.5rem; }
h1 { font-size: 1.6rem; font-weight: 650; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; font-weight: 650; margin: 3rem 0 .75rem; display: flex; gap: 1rem; align-items: baseline; }
h2 span { overflow-wrap: anywhere; } h2 .score { margin-left: auto; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
code, pre, .mono { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .86em; }
.soft { color: var(--soft); }
.score { font-variant-numeric: tabular-nums; white-space: nowrap; }
.total { margin-left: auto; font-size: 1.6rem; font-weight: 650; }
.tally { flex-basis: 100%; color: var(--soft); margin: 0; }
.bar { flex-basis: 100%; display: flex; gap: 3px; height: 8px; margin-top: .75rem; }
.bar span { flex: 1; border-radius: 3px; min-width: 2px; background: currentColor; }
.tools { margin: 1.25rem 0 .75rem; }
button { font: inherit; color: var(--accent); background: none; border: 1px solid var(--line); border-radius: 6px;
  padding: .2rem .7rem; cursor: pointer; }
button:hover { background: var(--tint); }
button[aria-pressed=true] { background: var(--accent); border-color: var(--accent); color: var(--card); }

.status { white-space: nowrap; font-weight: 550; }
.status::before { content: ""; display: inline-block; width: .6em; height: .6em; border-radius: 50%; margin-right: .5em;
  background: currentColor; }
.passed { color: var(--passed); } .failed { color: var(--failed); } .missing { color: var(--missing); }
.crashed, .timeout, .build_failed { color: var(--broken); }

table { border-collapse: collapse; width: 100%; background: var(--card); border: 1px solid var(--line);
  table-layout: fixed; }
th, td { text-align: left; vertical-align: top; padding: .5rem .8rem; border-top: 1px solid var(--line);
  overflow-wrap: anywhere; }
thead th { color: var(--soft); font-weight: 500; font-size: .85rem; border-top: 0; }
tbody th { background: var(--tint); font-weight: 650; }
td.score, th.score { text-align: right; }
th:first-child { width: 30%; } th.verdict { width: 9.5rem; } th.score { width: 7rem; }
td.reason { color: var(--soft); }

details.case { background: var(--card); border: 1px solid var(--line); border-radius: 8px; margin: .6rem 0;
  scroll-margin-top: 1rem; }
details.case > summary { display: flex; gap: .9rem; align-items: baseline; padding: .7rem 1rem; cursor: pointer;
  list-style: none; }
details.case > summary::-webkit-details-marker { display: none; }
summary .title { font-weight: 600; overflow-wrap: anywhere; } summary .score { margin-left: auto; }
summary .status { min-width: 7.2rem; }
.names { display: flex; flex-wrap: wrap; gap: .2rem 1rem; margin: .8rem 0 0; }
.body { padding: .3rem 1rem 1.2rem; border-top: 1px solid var(--line); }
dl { margin: .8rem 0; display: grid; grid-template-columns: 6.5rem 1fr; gap: .35rem 1rem; max-width: 56rem; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
dt.looks, dd.looks { font-weight: 600; } dd.looks { color: var(--failed); }
dd code { background: var(--tint); border-radius: 4px; padding: .15em .45em; margin-right: .6rem; }
dd button { font-size: .8rem; padding: 0 .5rem; }
pre { background: var(--tint); border-radius: 6px; padding: .8rem 1rem; overflow: auto; max-height: 28rem; margin: .6rem 0;
  white-space: pre-wrap; overflow-wrap: anywhere; }
pre.table { white-space: pre; overflow-wrap: normal; }
.figures { display: flex; flex-wrap: wrap; gap: .2rem 1.4rem; color: var(--soft); font-size: .85rem; margin: .4rem 0; }
.figures b { color: var(--ink); font-weight: 550; font-variant-numeric: tabular-nums; }

.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; margin-top: 1rem; }
figure { margin: 0; }
figcaption { font-size: .82rem; color: var(--soft); margin-top: .3rem; }
.pictures button { display: block; width: 100%; border: 0; border-radius: 4px; padding: 0; background: var(--tint);
  line-height: 0; cursor: zoom-in; overflow: hidden; }
.pictures img, .compare img { width: 100%; height: auto; display: block; }
img.small { image-rendering: pixelated; }
.compare { position: relative; border-radius: 4px; overflow: hidden; line-height: 0; }
.compare img + img { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--cut, 50%)); }
.compare::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut, 50%); width: 2px; margin-left: -1px;
  background: #fff; box-shadow: 0 0 0 1px #0008; pointer-events: none; }
.compare input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize; }
.compare:focus-within { outline: 2px solid var(--accent); outline-offset: 2px; }

dialog { border: 0; padding: 0; background: none; max-width: none; max-height: none; }
dialog:focus-visible { outline: none; }
dialog::backdrop { background: #15171a; }
dialog img { display: block; margin: 0 auto; image-rendering: pixelated; cursor: zoom-out; }
dialog figcaption { color: #d8dade; text-align: center; font-size: .95rem; margin-top: .8rem; }
dialog .soft { color: #8f969e; }

.filtered details.case.passed-case, .filtered tr.passed-case { display: none; }
footer { max-width: 72rem; margin: 3rem auto 0; padding: 1rem 1.5rem 3rem; color: var(--soft); font-size: .85rem; }

@media (max-width: 40rem) {
  dl { grid-template-columns: 1fr; gap: 0; } dd { margin-bottom: .5rem; }
  details.case > summary { flex-wrap: wrap; }
  table, tbody { display: block; } thead { display: none; }
  tr { display: grid; grid-template-columns: 1fr auto; border-top: 1px solid var(--line); }
  th, td { border: 0; padding: .3rem .8rem; } th:first-child, th.score { width: auto; }
  td:nth-child(2) { grid-row: 2; } td.reason { grid-row: 3; grid-column: 1 / -1; }
}
@media print {
  :root { --page: #fff; --card: #fff; --ink: #000; --soft: #444; --line: #bbb; --tint: #f3f3f3; color-scheme: light;
    --passed: #1d6a41; --failed: #9c2a22; --missing: #7a5508; --broken: #653787; --accent: #000; }
  body { font-size: 10pt; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .tools, .slider, dd button { display: none; }
  .pictures { grid-template-columns: repeat(4, 1fr); }
  figure, tr, dl { break-inside: avoid; } h2, summary { break-after: avoid; }
  pre { max-height: none; }
}
)css";

const std::string_view report_script = R"js(
"use strict";
const all = (selector, within = document) => [...within.querySelectorAll(selector)];

// A link from the table, or from the terminal, opens the case that it leads to.
function reveal() {
  const place = document.getElementById(decodeURIComponent(location.hash.slice(1)))?.closest("details");
  if (place) { place.open = true; place.scrollIntoView(); }
}
addEventListener("hashchange", reveal);
reveal();

// Paper cannot be clicked.
addEventListener("beforeprint", () => all("details").forEach(d => { d.open = true; }));

const filter = document.getElementById("filter");
filter.hidden = false;
filter.addEventListener("click", () => {
  const on = document.body.classList.toggle("filtered");
  filter.setAttribute("aria-pressed", String(on));
});

// Copying needs a secure page; where a browser refuses, the command can still be marked by hand.
for (const code of all("code.command")) {
  const button = document.createElement("button");
  button.textContent = "copy";
  button.addEventListener("click", async () => {
    try { await navigator.clipboard.writeText(code.textContent); button.textContent = "copied"; }
    catch { getSelection().selectAllChildren(code); button.textContent = "marked"; }
  });
  code.after(button);
}

// Reference on the left of the line, yours on the right; built from the pictures that the page has already.
for (const pictures of all(".pictures")) {
  const [reference, yours] = ["reference", "yours"].map(role => pictures.querySelector(`[data-role=${role}] img`));
  if (!reference || !yours || !pictures.querySelector("[data-role=difference]")) continue;
  const figure = document.createElement("figure");
  figure.className = "slider";
  const box = document.createElement("div");
  box.className = "compare";
  const range = document.createElement("input");
  Object.assign(range, {type: "range", min: 0, max: 100, step: 0.5, value: 50});
  range.setAttribute("aria-label", "How much of the reference to show; the rest is yours");
  range.addEventListener("input", () => box.style.setProperty("--cut", range.value + "%"));
  const copies = [reference, yours].map(image => image.cloneNode());
  copies.forEach(copy => { copy.alt = ""; });
  const caption = document.createElement("figcaption");
  caption.textContent = "Slide: reference | yours";
  box.append(...copies, range);
  figure.append(box, caption);
  pictures.querySelector("[data-role=difference]").after(figure);
}

// One picture at full size; the arrow keys change it in place, so that what differs seems to move.
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
)js";

}  // namespace atelier::judge
