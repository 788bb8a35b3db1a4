#include <cstdio>

int main(int count, char** arguments) {
    std::printf("from %s:", SOURCE);
    for (int each = 1; each < count; ++each) std::printf(" %s", arguments[each]);
    std::printf("\n");
}
