#include "keiko/report/markup/picture_slider.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {

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
    const std::string both = title + ": left before, right after";
    return figure("<div class=\"slider\">" +
                      image(pictures.before, pictures, title + " before", "") +
                      image(pictures.after, pictures, title + " after", "after") +
                      "</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
                      "aria-label=\"share of the picture that shows before\" "
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
        html += single(pictures.after, pictures, title + ": after");
    else if (!pictures.before.empty())
        html += single(pictures.before, pictures, title + ": before");
    if (!pictures.difference.empty())
        html += single(pictures.difference, pictures,
                       title +
                           ": difference, grey within, yellow to red beyond the tolerance, "
                           "magenta where the outline or the face is another");
    return html + "</div>\n";
}

} // namespace keiko
