/* Tables and verdicts: see report.h. */
#include "compare/report.h"

#include <math.h>
#include <stdio.h>

/* ---- the line of --csv ------------------------------------------------- */

static const char *const columns =
    "width,height,identical,mean,p99,largest,mean_relative,p99_relative,rmse,"
    "psnr,over,broken,flip,ssim,slope,bias,ratio,cpu_a,wall_a,cpu_b,wall_b";

static void report_csv(const struct report *report)
{
    const struct figures *f = &report->figures;
    const struct image *a = report->pair->image[0];
    double figures[] = {
        f->mean,
        f->percentile,
        f->largest,
        f->mean_relative,
        f->percentile_relative,
        f->rmse,
        f->psnr,
        f->over,
        (double)f->broken,
        report->flip,
        report->ssim,
        f->slope,
        f->bias,
        f->ratio,
    };
    printf("%d,%d,%d", a->width, a->height, report->pair->identical);
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++)
        printf(",%.9g", figures[i]);
    for (int i = 0; i < 2; i++) {
        if (report->times)
            printf(",%.3f,%.3f", report->times[i].processor,
                   report->times[i].wall);
        else
            printf(",,");
    }
    printf("\n");
}

/* ---- the table --------------------------------------------------------- */

static void report_line(const char *name, double figure, const char *remark)
{
    printf("%-24s %-*.4g%s\n", name, *remark ? 11 : 0, figure, remark);
}

static void report_differences(const struct figures *f, double threshold)
{
    char remark[128];
    snprintf(remark, sizeof remark, "%.3g of 255", f->mean * 255);
    report_line("mean difference", f->mean, remark);
    report_line("  99 % are up to", f->percentile, "");
    report_line("  largest", f->largest, "");
    report_line("mean relative", f->mean_relative, "");
    report_line("  99 % are up to", f->percentile_relative, "");
    report_line("RMSE", f->rmse, "");
    report_line("PSNR", f->psnr, "dB");
    snprintf(remark, sizeof remark, "%zu of %zu pixels, by more than %.4g",
             f->pixels_over, f->pixels, threshold);
    report_line("over the threshold", f->over, remark);
    if (f->broken)
        report_line("infinite or no number", (double)f->broken, "pixels");
}

static void report_times(const struct report *report)
{
    const struct times *a = &report->times[0], *b = &report->times[1];
    printf("%-24s %.2f s and %.2f s", "CPU time", a->processor, b->processor);
    if (a->processor > 0 && b->processor > 0)
        printf(": %s takes %.1f times less", report->names[1],
               a->processor / b->processor);
    printf("\n%-24s %.2f s and %.2f s\n", "wall time", a->wall, b->wall);
}

static void report_table(const struct report *report,
                         const struct choices *choices)
{
    static const char *const spaces[] = { "as displayed", "linear light",
                                          "raw numbers" };
    const struct figures *f = &report->figures;
    const struct image *a = report->pair->image[0];
    printf("A: %s\nB: %s\n%d x %d pixels, %s%s\n\n", report->names[0],
           report->names[1], a->width, a->height, spaces[report->pair->space],
           report->pair->identical ? "; identical" : "");
    report_differences(f, choices->threshold);
    report_line("FLIP", report->flip, "0 looks alike, 1 does not");
    report_line("SSIM", report->ssim, "1 is alike");
    report_line("B = slope * A + bias", f->slope, "");
    report_line("  bias", f->bias, "");
    report_line("mean of B / mean of A", f->ratio, "");
    if (report->times)
        report_times(report);
}

void report_print(const struct report *report, const struct choices *choices)
{
    if (choices->names_first)
        printf("%s\n", columns);
    if (choices->csv)
        report_csv(report);
    else if (!choices->quiet)
        report_table(report, choices);
}

/* ---- the verdict ------------------------------------------------------- */

struct verdict {
    const char *what, *option;
    double found, limit;
    bool least; /* the limit is a lower one */
};

/* So written that a figure that is no number fails. */
static bool verdict_kept(const struct verdict *verdict)
{
    if (isnan(verdict->limit))
        return true;
    return verdict->least ? verdict->found >= verdict->limit
                          : verdict->found <= verdict->limit;
}

__attribute__((format(printf, 3, 4))) static void
verdict_say(const struct report *report, FILE *out, const char *format, ...)
{
    if (!out)
        return;
    va_list arguments;
    va_start(arguments, format);
    fprintf(out, "glim-compare: '%s' and '%s' differ: ", report->names[0],
            report->names[1]);
    vfprintf(out, format, arguments);
    fprintf(out, "\n");
    va_end(arguments);
}

static bool report_within(const struct report *report,
                          const struct limits *limits, FILE *out)
{
    const struct figures *f = &report->figures;
    const struct verdict verdicts[] = {
        { "mean difference", "max-mean", f->mean, limits->mean, false },
        { "mean relative difference", "max-relative", f->mean_relative,
          limits->relative, false },
        { "RMSE", "max-rmse", f->rmse, limits->rmse, false },
        { "PSNR", "min-psnr", f->psnr, limits->psnr, true },
        { "share of pixels over the threshold", "max-over", f->over,
          limits->over, false },
        { "FLIP", "max-flip", report->flip, limits->flip, false },
        { "SSIM", "min-ssim", report->ssim, limits->ssim, true },
    };
    bool within = true;
    for (size_t i = 0; i < sizeof verdicts / sizeof *verdicts; i++) {
        if (verdict_kept(&verdicts[i]))
            continue;
        within = false;
        verdict_say(report, out, "the %s is %.6g, --%s %.6g", verdicts[i].what,
                    verdicts[i].found, verdicts[i].option, verdicts[i].limit);
    }
    return within;
}

bool report_alike(const struct report *report, const struct choices *choices,
                  struct diag *diag)
{
    const struct figures *f = &report->figures;
    FILE *out = choices->quiet ? NULL : diag->out;
    if (report->pair->identical)
        return true;
    if (f->broken) {
        verdict_say(report, out,
                    "%zu pixels are infinite or no number in one of them",
                    f->broken);
        return false;
    }
    if (limits_any(&choices->limits))
        return report_within(report, &choices->limits, out);
    if (!choices->scene)
        verdict_say(report, out,
                    "%zu of %zu pixels by more than %.4g, the "
                    "largest by %.4g",
                    f->pixels_over, f->pixels, choices->threshold, f->largest);
    return choices->scene;
}
