#include "keiko/report/markup/html_page.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

/// The report's style sheet: light and dark by the reader's setting, and for print.
constexpr std::string_view report_style = R"css(
:root { color-scheme: light dark;
  --page: #f6f7f8; --card: #ffffff; --ink: #16191d; --soft: #5c6670; --line: #dfe3e7;
  --fail: #c42b1c; --undecided: #b26a00; --pass: #15803d; --crease: #64748b; --open: #7c3aed;
  --tint: #eef1f4; }
@media (prefers-color-scheme: dark) { :root {
  --page: #101214; --card: #191c1f; --ink: #e8eaed; --soft: #9aa5b1; --line: #2c3136;
  --fail: #ff6b5e; --undecided: #f5a524; --pass: #4ade80; --crease: #94a3b8; --open: #a78bfa;
  --tint: #22262a; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  font-variant-numeric: tabular-nums; }
main { max-width: 1180px; margin: 0 auto; padding: 28px 24px 48px; }
h1 { font-size: 20px; font-weight: 650; margin: 0; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 13px; font-weight: 650; margin: 36px 0 12px; color: var(--soft);
  text-transform: uppercase; letter-spacing: 0.06em; }
p { margin: 0 0 8px; }
.soft { color: var(--soft); }
.small { font-size: 13px; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.fail { --tone: var(--fail); } .undecided, .look { --tone: var(--undecided); }
.pass { --tone: var(--pass); } .crease { --tone: var(--crease); } .open { --tone: var(--open); }
.head { display: flex; gap: 24px; align-items: center; padding: 20px 24px; flex-wrap: wrap;
  border-left: 6px solid var(--tone); }
.head .names { flex: 1 1 320px; min-width: 0; }
.verdict { font-size: 34px; font-weight: 750; line-height: 1.1; color: var(--tone);
  letter-spacing: -0.02em; text-transform: capitalize; }
.counts { display: grid; grid-template-columns: repeat(auto-fit, minmax(112px, 1fr)); gap: 12px;
  margin-top: 12px; }
.count { padding: 12px 16px; }
.count { color: inherit; text-decoration: none; }
.count b { display: block; font-size: 26px; font-weight: 680; line-height: 1.2; color: var(--tone); }
.count.none b { color: var(--soft); font-weight: 500; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(340px, 100%), 1fr)); gap: 16px; }
.pictures > :only-child { max-width: 820px; }
figure { margin: 0; overflow: hidden; break-inside: avoid; }
figcaption { padding: 9px 14px; }
.pictures + .card, .pictures + .worst { margin-top: 16px; }
.picture { position: relative; background: #000; line-height: 0; }
.picture img { width: 100%; height: auto; }
.marker { position: absolute; transform: translate(-50%, -50%); width: 24px; height: 24px;
  border-radius: 50%; background: #e5261f; color: #fff; border: 2px solid #fff; text-align: center;
  font-size: 12px; line-height: 20px; font-weight: 700; box-shadow: 0 1px 5px #000a;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.worst { display: grid; gap: 12px; }
.seam { display: flex; gap: 20px; padding: 16px 20px; align-items: center; break-inside: avoid;
  border-left: 4px solid var(--tone); }
.rank { flex: none; width: 30px; height: 30px; border-radius: 50%; background: var(--tone);
  color: var(--card); font-weight: 700; text-align: center; line-height: 30px;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.seam .body { flex: 1 1 auto; min-width: 0; }
.seam .name { font-weight: 620; overflow-wrap: anywhere; }
.seam img { flex: none; width: 280px; border-radius: 6px; }
[data-shot] { cursor: zoom-in; } [data-shot]:hover td, [data-shot]:focus-visible td { background: var(--tint); }
dialog { border: 1px solid var(--line); border-radius: 10px; background: var(--card); color: var(--ink);
  max-width: min(760px, 94vw); padding: 16px; } dialog::backdrop { background: #000a; }
dialog img { width: 720px; max-width: 100%; border-radius: 6px; } dialog p { margin: 8px 0; }
.combs { padding: 8px; margin-bottom: 12px; } .combs svg { display: block; width: 100%; height: auto; border-radius: 6px; }
.profile { display: block; width: 100%; max-width: 760px; height: auto; margin-top: 12px; }
.profile text { font-size: 11px; fill: var(--soft); } .profile path { fill: none; stroke-linejoin: round; }
.profile .axis { stroke: var(--line); } .profile .limit { stroke: var(--fail); stroke-dasharray: 4 3; }
.profile .value { stroke: var(--ink); stroke-width: 1.3; } .profile .b { stroke: var(--open); stroke-dasharray: 6 3; }
.profile .beyond { fill: var(--fail); opacity: 0.16; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.profiled { padding: 8px 16px; } .profiled summary { margin: 0; overflow-wrap: anywhere; }
.measures { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 8px 24px;
  margin-top: 10px; }
.measure b { font-size: 16px; font-weight: 650; color: var(--tone); white-space: nowrap; }
.bar { height: 4px; border-radius: 2px; background: var(--tint); margin: 4px 0 2px; position: relative; }
.bar i { position: absolute; inset: 0 auto 0 0; border-radius: 2px; background: var(--tone);
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.coverage { padding: 18px 24px; }
.coverage b { font-size: 26px; font-weight: 680; }
.coverage .bar { height: 8px; border-radius: 4px; margin: 8px 0 12px; max-width: 520px; }
.coverage .bar i { border-radius: 4px; background: var(--pass); }
.scroll { overflow: auto; max-height: 640px; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; }
th, td { padding: 7px 12px; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
tbody tr:last-child td { border-bottom: 0; }
th { position: sticky; top: 0; background: var(--card); color: var(--soft); font-weight: 600; }
th button { all: unset; cursor: pointer; } th button:hover, th button:focus-visible { color: var(--ink); text-decoration: underline; }
th[aria-sort=ascending] button::after { content: " \2191"; }
th[aria-sort=descending] button::after { content: " \2193"; }
.left { text-align: left; white-space: normal; overflow-wrap: anywhere; min-width: 180px; }
td.tone { color: var(--tone); font-weight: 620; }
.chip { display: inline-block; padding: 0 9px; border-radius: 10px; font-size: 12px; font-weight: 650;
  color: var(--tone); border: 1px solid var(--tone); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 6px 24px; margin: 0; padding: 18px 24px; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
details { margin-top: 12px; } summary { cursor: pointer; color: var(--soft); margin-bottom: 8px; }
ul { margin: 0; padding: 0 0 0 18px; }
footer { margin-top: 32px; color: var(--soft); font-size: 13px; }
@media (max-width: 1050px) { .counts:has(> :nth-child(7)) { grid-template-columns: repeat(4, 1fr); } }
@media (max-width: 560px) { .counts, .counts:has(> :nth-child(7)) { grid-template-columns: 1fr 1fr; }
  .counts > :last-child:nth-child(odd) { grid-column: span 2; } }
@media (max-width: 720px) { .seam { flex-wrap: wrap; align-items: flex-start; } .seam img { width: 100%; }
  .seam .body { flex-basis: calc(100% - 50px); }
  .measures { grid-template-columns: 1fr; } }
@media print { :root { --page: #fff; --card: #fff; --ink: #000; --soft: #444; --line: #ccc; --tint: #eee; }
  main { max-width: none; padding: 0; } .scroll { max-height: none; overflow: visible; }
  th { position: static; } h2 { break-after: avoid; } }
)css";

} // namespace

const std::string_view report_script = R"js(
for (const button of document.querySelectorAll("th button")) button.onclick = () => {
  const head = button.parentElement, table = head.closest("table"), body = table.tBodies[0];
  const up = head.getAttribute("aria-sort") === "descending", column = head.cellIndex;
  for (const other of head.parentElement.cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const key = row => row.cells[column].dataset.v ?? "";
  const order = (a, b) => a === "" || b === "" ? (a === "") - (b === "")
    : (up ? 1 : -1) * (isNaN(a) || isNaN(b) ? a.localeCompare(b) : a - b);
  body.append(...[...body.rows].sort((a, b) => order(key(a), key(b))));
};
const viewer = document.getElementById("viewer");
const show = (image, words) => {
  const copy = image.cloneNode();
  copy.removeAttribute("id");
  viewer.querySelector("img").replaceWith(copy);
  viewer.querySelector("p").textContent = words;
  viewer.showModal();
};
for (const row of document.querySelectorAll("[data-shot]")) {
  const open = () => show(document.getElementById(row.dataset.shot),
    [...row.closest("table").tHead.rows[0].cells].map((head, i) => head.textContent + ": " + row.cells[i].textContent).join(" · "));
  row.onclick = open;
  row.onkeydown = event => { if (event.key === "Enter") open(); };
}
for (const image of document.querySelectorAll(".seam .shot"))
  image.onclick = () => show(image, image.parentElement.querySelector(".name").textContent);
)js";

std::string html_page(std::string_view title, std::string_view more_style, std::string_view body,
                      std::string_view script) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Keiko: ";
    html.append(title) += "</title>\n<style>";
    html.append(report_style).append(more_style);
    html += "</style>\n</head>\n<body>\n<main>\n";
    html.append(body) += "</main>\n";
    if (!script.empty()) html.append("<script>").append(script) += "</script>\n";
    return html + "</body>\n</html>\n";
}

const std::string_view slider_style = R"css(
.slider { --cut: 50%; position: relative; background: #000; line-height: 0; }
.slider img, .picture.small-pixels img { width: 100%; height: auto; image-rendering: pixelated; }
.slider .after { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--cut)); }
.slider::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut); width: 1px;
  background: #fff; }
.slider + input { width: 100%; margin: 8px 0 0; }
.triple { display: grid; grid-template-columns: repeat(auto-fit, minmax(340px, 1fr)); gap: 16px;
  margin-bottom: 16px; }
)css";

namespace {

std::string image(std::string_view png, const SliderPictures& pictures, const std::string& title,
                  const std::string& css_class) {
    return "<img" + (css_class.empty() ? "" : " class=\"" + css_class + "\"") + " alt=\"" +
           html_escaped(title) + "\" width=\"" + std::to_string(pictures.width) + "\" height=\"" +
           std::to_string(pictures.height) + "\" src=\"data:image/png;base64," + base64(png) +
           "\">";
}

std::string figure(const std::string& content, const std::string& caption) {
    return "<figure class=\"card\">" + content + "<figcaption>" + html_escaped(caption) +
           "</figcaption></figure>";
}

std::string single(std::string_view png, const SliderPictures& pictures, const std::string& title) {
    return figure(
        "<div class=\"picture small-pixels\">" + image(png, pictures, title, "") + "</div>", title);
}

std::string sliding(const SliderPictures& pictures, const std::string& title) {
    const SliderWords& words = pictures.words;
    const std::string both = title + ": left " + words.before + ", right " + words.after;
    return figure("<div class=\"slider\">" +
                      image(pictures.before, pictures, title + " " + words.before, "") +
                      image(pictures.after, pictures, title + " " + words.after, "after") +
                      "</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
                      "aria-label=\"share of the picture that shows " +
                      html_escaped(words.before) +
                      "\" "
                      "oninput=\"this.previousElementSibling.style.setProperty('--cut', "
                      "this.value + '%')\">",
                  both);
}

} // namespace

std::string html_slider(const SliderPictures& pictures, const std::string& title) {
    std::string html = "<div class=\"triple\">";
    if (!pictures.before.empty() && !pictures.after.empty())
        html += sliding(pictures, title);
    else if (!pictures.after.empty())
        html += single(pictures.after, pictures, title + ": " + pictures.words.after);
    else if (!pictures.before.empty())
        html += single(pictures.before, pictures, title + ": " + pictures.words.before);
    if (!pictures.difference.empty())
        html += single(pictures.difference, pictures, title + ": " + pictures.words.difference);
    return html + "</div>\n";
}

} // namespace keiko
