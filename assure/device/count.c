/* A plugin of QEMU: the most instructions that a call of one function takes, the functions under it
 * included. `begin=ADDRESS` is the function; a call ends where the instruction after the one that
 * called it is reached. Prints `calls=N most=M` when the machine stops.
 *
 * The declarations are those of QEMU's plugin interface, version 1, so that no header is needed. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum flags { NO_REGISTERS };
extern void qemu_plugin_register_vcpu_tb_trans_cb(
    qemu_plugin_id_t id, void (*callback)(qemu_plugin_id_t, struct qemu_plugin_tb *));
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);
extern size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *);
extern void qemu_plugin_register_vcpu_insn_exec_cb(
    struct qemu_plugin_insn *, void (*callback)(unsigned, void *), enum flags, void *);
extern void qemu_plugin_register_atexit_cb(
    qemu_plugin_id_t id, void (*callback)(qemu_plugin_id_t, void *), void *);

#define SHOWN __attribute__((visibility("default")))
SHOWN int qemu_plugin_version = 1;

static uint64_t begin, after, end, count, calls, most;
static int inside;

/* `what` holds the address of an instruction in 32 bits, and its size above them. */
static void executed(unsigned processor, void *what)
{
    const uint64_t address = (uintptr_t)what & 0xffffffffu;
    const uint64_t size = (uintptr_t)what >> 32;
    (void)processor;
    if (inside && (address == end)) {
        inside = 0;
        calls++;
        most = (count > most) ? count : most;
    }
    if (!inside && (address == begin)) {
        inside = 1;
        count = 0;
        end = after;
    }
    count += (uint64_t)inside;
    after = address + size;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
        struct qemu_plugin_insn *one = qemu_plugin_tb_get_insn(block, i);
        const uint64_t what = qemu_plugin_insn_vaddr(one) | ((uint64_t)qemu_plugin_insn_size(one) << 32);
        qemu_plugin_register_vcpu_insn_exec_cb(one, executed, NO_REGISTERS, (void *)(uintptr_t)what);
    }
}

static void stopped(qemu_plugin_id_t id, void *data)
{
    (void)id;
    (void)data;
    fprintf(stderr, "calls=%llu most=%llu\n", (unsigned long long)calls, (unsigned long long)most);
}

SHOWN int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int count_of, char **arguments)
{
    (void)info;
    for (int i = 0; i < count_of; i++) {
        if (strncmp(arguments[i], "begin=", 6) == 0) {
            /* The lowest bit says Thumb. */
            begin = strtoull(arguments[i] + 6, NULL, 0) & ~1ull;
        }
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, stopped, NULL);
    return 0;
}
