/* Start of a program on a Cortex-M under QEMU: memory, the floating-point unit, main, and an exit by
 * semihosting with what main returned. */
#include <stdint.h>
#include <stdlib.h>

extern void stack_top(void);
extern uint32_t data_start, data_end, data_load, bss_start, bss_end;
extern int main(void);
extern void initialise_monitor_handles(void);
void reset(void);
void _init(void);
void _fini(void);

/* Where the linker's start files would bring them. */
void _init(void) {}
void _fini(void) {}

/* A fault ends the run as a failure: SYS_EXIT with ADP_Stopped_RunTimeErrorUnknown. */
static void fault(void)
{
    register uint32_t operation __asm__("r0") = 0x18u;
    register uint32_t reason __asm__("r1") = 0x20023u;
    __asm__ volatile("bkpt 0xab" ::"r"(operation), "r"(reason));
    for (;;) {
    }
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    stack_top, reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault
};

void reset(void)
{
    const uint32_t *from = &data_load;
    for (uint32_t *to = &data_start; to < &data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = &bss_start; to < &bss_end; to++) {
        *to = 0u;
    }
#ifdef __ARM_FP
    /* CPACR: coprocessors 10 and 11. */
    *(volatile uint32_t *)0xE000ED88u |= (0xFu << 20);
    __asm__ volatile("dsb\n isb");
#endif
    initialise_monitor_handles();
    exit(main());
}
