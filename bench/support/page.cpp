#include "page.hpp"

#include "plot.hpp"

#include <meniscus/data/drawing/image.hpp>
#include <meniscus/data/text/printable.hpp>

#include <fmt/format.h>

namespace meniscus {
namespace {

constexpr const char* head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ margin: 0 auto; max-width: 1200px; padding: 0 1rem 2rem; font: 15px/1.45 system-ui, sans-serif; }}
section {{ overflow-x: auto; }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums; }}
th, td {{ padding: 0.2rem 0.6rem; text-align: right; border-bottom: 1px solid #8888; }}
th:first-child, td:first-child {{ text-align: left; }}
th button {{ all: unset; cursor: pointer; font-weight: 600; }}
th button:focus-visible {{ outline: 2px solid; }}
svg {{ max-width: 100%; height: auto; margin: 1rem 0; }}
</style>
<h1>{0}</h1>
<p>{1}</p>
)";

constexpr const char* script = R"(<script>
for (const button of document.querySelectorAll("th button"))
  button.addEventListener("click", () => {
    const heading = button.parentElement;
    const column = [...heading.parentElement.children].indexOf(heading);
    const up = heading.getAttribute("aria-sort") !== "ascending";
    const body = heading.closest("table").tBodies[0];
    const of = (row) => row.cells[column].textContent;
    const order = (a, b) => parseFloat(of(a)) - parseFloat(of(b)) || of(a).localeCompare(of(b));
    body.append(...[...body.rows].sort((a, b) => (up ? order(a, b) : order(b, a))));
    for (const other of heading.parentElement.children) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", up ? "ascending" : "descending");
  });
</script>
)";

std::string escaped(const std::string& text) {
    return escaped_in_svg(printable(text));
}

std::string html_of(const Table& table) {
    std::string html = "<table>\n<thead><tr>";
    for (const Column& column : table.columns)
        html += "<th><button>" + escaped(column.heading) + "</button></th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (const std::string& text : texts_of(table, row))
            html += "<td>" + escaped(text) + "</td>";
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n";
}

} // namespace

std::string tables_page(const std::string& title, const std::string& about,
                        const std::vector<Table>& tables) {
    std::string page = fmt::format(fmt::runtime(head), escaped(title), escaped(about));
    for (const Table& table : tables) {
        page += fmt::format("<section>\n<h2>{}</h2>\n{}", escaped(table.title), html_of(table));
        for (const Plot& plot : table.plots)
            page += svg_of(table, plot);
        page += "</section>\n";
    }
    return page + script + "</html>\n";
}

} // namespace meniscus
