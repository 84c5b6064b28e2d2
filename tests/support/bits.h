/* Numbers as their bits, in hexadecimal, from stdin and to stdout. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static double number(void)
{
    char text[32] = "";
    if (scanf("%31s", text) != 1) exit(3);
    const uint64_t bits = strtoull(text, NULL, 16);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
static void show(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value != value) printf(" nan"); else printf(" %016" PRIx64, bits);
}
