#include "keiko/report/markup/html_page.h"

#include "keiko/report/markup/report_style.h"

namespace keiko {

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

} // namespace keiko
