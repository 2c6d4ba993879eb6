"use strict";
const table = document.getElementById("class"), body = table.tBodies[0];
const rows = [...body.rows], headings = [...table.tHead.rows[0].cells];

// A cell's number, or its text; null if it is empty, which is sorted last whatever the direction.
function value(row, column) {
  const cell = row.cells[column];
  if ("value" in cell.dataset) return Number(cell.dataset.value);
  return cell.className === "absent" || !cell.textContent ? null : cell.textContent;
}
const words = new Intl.Collator(undefined, {numeric: true});
function compare(a, b, sign) {
  if (a === null || b === null) return (a === null) - (b === null);
  return sign * (typeof a === "number" && typeof b === "number" ? a - b : words.compare(a, b));
}

// The first click sorts texts upwards and numbers downwards, the next turns that round.
headings.forEach((heading, column) => heading.querySelector("button").addEventListener("click", () => {
  const numbers = rows.some(row => "value" in row.cells[column].dataset);
  const last = heading.getAttribute("aria-sort");
  const down = last ? last === "ascending" : numbers;
  headings.forEach(each => each.removeAttribute("aria-sort"));
  heading.setAttribute("aria-sort", down ? "descending" : "ascending");
  rows.sort((a, b) => compare(value(a, column), value(b, column), down ? -1 : 1));
  body.append(...rows);
}));

const search = document.getElementById("search"), human = document.getElementById("human");
const shown = document.getElementById("shown");
function filter() {
  const wanted = search.value.trim().toLowerCase();
  let number = 0;
  for (const row of rows) {
    const text = (row.cells[0].textContent + " " + row.cells[1].textContent).toLowerCase();
    row.hidden = !text.includes(wanted) || (human.checked && !row.querySelector(".human"));
    number += row.hidden ? 0 : 1;
  }
  shown.textContent = number === rows.length ? "" : `${number} of ${rows.length}`;
}
search.addEventListener("input", filter);
human.addEventListener("change", filter);
document.querySelector(".tools").hidden = false;
filter();
