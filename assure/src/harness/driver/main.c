/* Runs the controllers of the table on the records of records.bin and leaves outcomes.bin, both in
 * the working folder. For each controller in turn, records.bin holds a count in 4 bytes and so many
 * records. Exit code 1: a file lacks something. */
#include <stdint.h>
#include <stdio.h>

typedef struct {
    void (*drive)(const void *record, int32_t status[4], void *u);
    uint32_t numbers; /* of a record */
    uint32_t size;    /* of a number, in bytes */
} controller;

#include TABLE

int main(void)
{
    static double record[LONGEST];
    FILE *in = fopen("records.bin", "rb");
    FILE *out = fopen("outcomes.bin", "wb");

    if ((in == NULL) || (out == NULL)) {
        return 1;
    }
    for (uint32_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        uint32_t count = 0;

        if (fread(&count, sizeof count, 1, in) != 1) {
            return 1;
        }
        for (uint32_t j = 0; j < count; j++) {
            int32_t status[4] = { 0, 0, 0, 0 };
            double u[3] = { 0.0, 0.0, 0.0 };

            if (fread(record, (size_t)table[i].size, table[i].numbers, in) != table[i].numbers) {
                return 1;
            }
            table[i].drive(record, status, u);
            if ((fwrite(status, sizeof status, 1, out) != 1)
                || (fwrite(u, (size_t)table[i].size, 3, out) != 3)) {
                return 1;
            }
        }
    }
    return (fclose(out) == 0) ? 0 : 1;
}
