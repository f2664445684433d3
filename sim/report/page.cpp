#include "sim/report/page.h"

namespace sim::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --page: #f6f7f9; --card: #fff; --ink: #14181f; --soft: #5b6472; --line: #dfe3e9;
  --good: #137a4b; --bad: #b3261e; --open: #8a6100; --blue: #1769d2; }
@media (prefers-color-scheme: dark) {
  :root { --page: #10141a; --card: #181d25; --ink: #e8ecf2; --soft: #9aa5b5; --line: #2b323d;
    --good: #4fc38a; --bad: #ff8a80; --open: #e3b341; --blue: #6aa8ff; } }
* { box-sizing: border-box; }
body { margin: 0; padding: 28px 20px 48px; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; }
main { max-width: 1180px; margin: 0 auto; }
h1 { font-size: 25px; line-height: 1.3; margin: 10px 0 6px; text-wrap: balance; }
.soft, th { color: var(--soft); font-size: 13.5px; font-weight: 500; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 14px 16px; min-width: 0; }
table { border-collapse: collapse; width: 100%; } tr + tr > * { border-top: 1px solid var(--line); }
@media print { body { padding: 0; background: #fff; } .card, tr { break-inside: avoid; } }
)";

}  // namespace

std::string escaped(const std::string& plain) {
  std::string all;
  for (const char c : plain) {
    switch (c) {
      case '&': all += "&amp;"; break;
      case '<': all += "&lt;"; break;
      case '>': all += "&gt;"; break;
      case '"': all += "&quot;"; break;
      default: all += c;
    }
  }
  return all;
}

std::string html_page(const std::string& title, const char* style, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + kStyle + style + "</style></head>\n<body><main>\n" + body +
         "</main></body></html>\n";
}

}  // namespace sim::report
