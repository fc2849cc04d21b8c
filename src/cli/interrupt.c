/* Signals to flags: see interrupt.h. A handler has no argument, so this is
 * a mutable file-scope variable; make's jobserver is the other. */
#include "cli/interrupt.h"

#include <signal.h>
#include <stddef.h>

static atomic_int flag;

static void interrupt_handle(int number)
{
    (void)number;
    atomic_store(&flag, 1);
}

const atomic_int *interrupt_catch(void)
{
    static const int numbers[] = { SIGINT, SIGTERM, SIGHUP };
    struct sigaction action = { .sa_handler = interrupt_handle,
                                .sa_flags = (int)SA_RESETHAND };
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        struct sigaction before;
        sigaction(numbers[i], NULL, &before);
        if (before.sa_handler != SIG_IGN) /* nohup */
            sigaction(numbers[i], &action, NULL);
    }
    /* Past the limit of ulimit -f, write() fails as on a full disk. */
    action.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &action, NULL);
    return &flag;
}
