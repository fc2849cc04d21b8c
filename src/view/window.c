/* SDL's surfaces: see window.h. */
#include "view/window.h"

#include <SDL2/SDL_ttf.h>
#include <string.h>

#include "base/memory.h"
#include "image/file.h"

enum { FONT_SIZE = 13, MARGIN = 6, LINE_LIMIT = 400 };

struct window {
    SDL_Window *window;
    SDL_Surface *surface; /* between begin and show */
    SDL_Surface *shown;   /* a copy of what was shown last */
    TTF_Font *font;
};

/* Where Debian and others have fonts whose letters are equally wide. */
static TTF_Font *font_open(void)
{
    static const char *const paths[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
        "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
        "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf",
        "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
        "/usr/share/fonts/truetype/povray/cyrvetic.ttf",
    };
    const char *own = SDL_getenv("GLIM_VIEW_FONT");
    TTF_Font *font = own ? TTF_OpenFont(own, FONT_SIZE) : NULL;
    for (size_t i = 0; !font && i < sizeof paths / sizeof *paths; i++)
        font = TTF_OpenFont(paths[i], FONT_SIZE);
    return font;
}

struct window *window_open(const char *title, int width, int height,
                           struct diag *diag)
{
    struct window *window = memory_new(sizeof *window);
    SDL_Rect usable;
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "there is no display for a window: %s; glim --watch renders "
                   "again whenever a file changes, without one",
                   SDL_GetError());
        memory_free(window);
        return NULL;
    }
    if (SDL_GetDisplayUsableBounds(0, &usable) == 0) {
        width = width < usable.w ? width : usable.w;
        height = height < usable.h ? height : usable.h;
    }
    window->window = SDL_CreateWindow(
        title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, width, height,
        SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (window->window && TTF_Init() == 0)
        window->font = font_open();
    if (window->window && window->font)
        return window;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               window->window ? "no font is there: install fonts-dejavu-core, "
                                "or name one by GLIM_VIEW_FONT (%s)"
                              : "can't open a window: %s",
               SDL_GetError());
    window_close(window);
    return NULL;
}

void window_close(struct window *window)
{
    if (!window)
        return;
    if (window->font)
        TTF_CloseFont(window->font);
    if (TTF_WasInit())
        TTF_Quit();
    SDL_FreeSurface(window->shown);
    if (window->window)
        SDL_DestroyWindow(window->window);
    SDL_Quit();
    memory_free(window);
}

void window_resize(struct window *window, int width, int height)
{
    SDL_SetWindowSize(window->window, width, height);
}

int window_line(const struct window *window)
{
    return TTF_FontLineSkip(window->font);
}

bool window_begin(struct window *window)
{
    window->surface = SDL_GetWindowSurface(window->window);
    if (window->surface)
        SDL_FillRect(window->surface, NULL, 0);
    return window->surface;
}

void window_show(struct window *window)
{
    SDL_Surface *from = window->surface, *copy = window->shown;
    if (!copy || copy->w != from->w || copy->h != from->h) {
        SDL_FreeSurface(copy);
        copy = SDL_CreateRGBSurfaceWithFormat(0, from->w, from->h, 32,
                                              SDL_PIXELFORMAT_RGB888);
        window->shown = copy;
    }
    if (copy)
        SDL_BlitSurface(from, NULL, copy, NULL);
    SDL_UpdateWindowSurface(window->window);
    window->surface = NULL;
}

SDL_Rect window_area(const struct window *window)
{
    return (SDL_Rect){ 0, 0, window->surface->w, window->surface->h };
}

/* Pixels of the canvas; with an opacity they are blended. */
static void window_pixels(struct window *window, const struct canvas *canvas,
                          unsigned *pixels, Uint32 format, const SDL_Rect *to)
{
    SDL_Rect area = *to;
    SDL_Surface *picture = pixels ? SDL_CreateRGBSurfaceWithFormatFrom(
                                        pixels, canvas->width, canvas->height,
                                        32, canvas->width * 4, format)
                                  : NULL;
    if (picture)
        SDL_BlitScaled(picture, NULL, window->surface, &area);
    SDL_FreeSurface(picture);
}

void window_picture(struct window *window, struct canvas *canvas,
                    const SDL_Rect *to)
{
    SDL_LockMutex(canvas->lock);
    window_pixels(window, canvas, canvas->pixels, SDL_PIXELFORMAT_RGB888, to);
    window_pixels(window, canvas, canvas->layer, SDL_PIXELFORMAT_ARGB8888, to);
    SDL_UnlockMutex(canvas->lock);
}

void window_picture_from(struct window *window, struct canvas *canvas,
                         const SDL_Rect *to, int left)
{
    const SDL_Rect clip = { left, to->y, to->x + to->w - left, to->h };
    SDL_SetClipRect(window->surface, &clip);
    window_picture(window, canvas, to);
    SDL_SetClipRect(window->surface, NULL);
}

void window_fill(struct window *window, const SDL_Rect *area, unsigned tint,
                 int opacity)
{
    SDL_Surface *paint =
        SDL_CreateRGBSurfaceWithFormat(0, 1, 1, 32, SDL_PIXELFORMAT_ARGB8888);
    SDL_Rect to = *area;
    if (!paint)
        return;
    *(unsigned *)paint->pixels = (unsigned)opacity << 24 | tint;
    SDL_SetSurfaceBlendMode(paint, SDL_BLENDMODE_BLEND);
    SDL_BlitScaled(paint, NULL, window->surface, &to);
    SDL_FreeSurface(paint);
}

void window_frame(struct window *window, const SDL_Rect *area, unsigned tint)
{
    const SDL_Rect sides[] = {
        { area->x, area->y, area->w, 1 },
        { area->x, area->y + area->h - 1, area->w, 1 },
        { area->x, area->y, 1, area->h },
        { area->x + area->w - 1, area->y, 1, area->h },
    };
    for (int i = 0; i < 4; i++)
        window_fill(window, &sides[i], tint, 255);
}

int window_text(struct window *window, int x, int y, int right, unsigned tint,
                const char *text)
{
    SDL_Color paint = { (Uint8)(tint >> 16), (Uint8)(tint >> 8), (Uint8)tint,
                        255 };
    char line[LINE_LIMIT];
    snprintf(line, sizeof line, "%s", text);
    SDL_Surface *letters =
        line[0] ? TTF_RenderUTF8_Blended(window->font, line, paint) : NULL;
    if (!letters)
        return x;
    SDL_Rect from = { 0, 0, letters->w, letters->h }, to = { x, y, 0, 0 };
    if (x + from.w > right)
        from.w = right - x;
    if (from.w > 0)
        SDL_BlitSurface(letters, &from, window->surface, &to);
    SDL_FreeSurface(letters);
    return x + from.w;
}

size_t window_fit(const struct window *window, const char *text, int width)
{
    int wide = 0, letters = 0;
    char line[LINE_LIMIT];
    snprintf(line, sizeof line, "%s", text);
    TTF_MeasureUTF8(window->font, line, width, &wide, &letters);
    size_t bytes = 0, word = 0;
    for (letters = letters > 1 ? letters : 1; line[bytes] && letters > 0;
         letters--) {
        bytes++;
        while ((line[bytes] & 0xc0) == 0x80) /* the rest of the letter */
            bytes++;
        if (line[bytes - 1] == ' ')
            word = bytes;
    }
    return line[bytes] && word ? word : bytes;
}

/* The next line of a text, without its end; NULL after the last. */
static const char *text_line(const char *text, char line[LINE_LIMIT])
{
    size_t length = strcspn(text, "\n");
    if (!*text)
        return NULL;
    snprintf(line, LINE_LIMIT, "%.*s", (int)length, text);
    return text + length + (text[length] != '\0');
}

/* How large a box of the text is, at (x, y). */
static SDL_Rect window_box_area(const struct window *window, int x, int y,
                                const char *text)
{
    char line[LINE_LIMIT];
    int width = 0, lines = 0;
    for (const char *next = text; (next = text_line(next, line)) != NULL;
         lines++) {
        int wide = 0;
        TTF_SizeUTF8(window->font, line, &wide, NULL);
        width = wide > width ? wide : width;
    }
    return (SDL_Rect){ x, y, width + 2 * MARGIN,
                       lines * window_line(window) + 2 * MARGIN };
}

void window_box(struct window *window, int x, int y, unsigned tint,
                const char *text)
{
    char line[LINE_LIMIT];
    int high = window_line(window);
    SDL_Rect all = window_area(window);
    SDL_Rect box = window_box_area(window, x, y, text);
    if (box.w > all.w - x)
        box.w = all.w - x;
    window_fill(window, &box, 0x101418, 225);
    for (const char *next = text; (next = text_line(next, line)) != NULL;) {
        window_text(window, x + MARGIN, y + MARGIN, box.x + box.w, tint, line);
        y += high;
    }
}

void window_label(struct window *window, int x, int y, unsigned tint,
                  const char *text)
{
    SDL_Rect all = window_area(window);
    SDL_Rect box = window_box_area(window, x, y, text);
    x = x + box.w > all.w ? all.w - box.w : x;
    y = y + box.h > all.h ? all.h - box.h : y;
    window_box(window, x < 0 ? 0 : x, y < 0 ? 0 : y, tint, text);
}

bool window_save(const struct window *window, const char *path,
                 struct diag *diag)
{
    const SDL_Surface *shown = window->shown;
    char why[256] = "nothing was shown yet";
    const struct image_format format = { .type = "png", .bits = 8 };
    struct image *image = shown ? image_new(shown->w, shown->h) : NULL;
    for (int y = 0; image && y < shown->h; y++) {
        const unsigned *row =
            (const unsigned *)((const char *)shown->pixels + y * shown->pitch);
        for (int x = 0; x < shown->w; x++) {
            float *pixel = image_pixel(image, x, y);
            for (int k = 0; k < 3; k++)
                pixel[k] = (float)(row[x] >> (16 - 8 * k) & 255) / 255;
            pixel[3] = 1;
        }
    }
    bool done = image && image_write(image, path, &format, why, sizeof why);
    image_free(image);
    if (!done)
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't write '%s': %s",
                   path, why);
    return done;
}
