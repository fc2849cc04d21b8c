/* Photons, unsaid: see photon.h. */
#include "scene/photon.h"

const struct photon_flags photon_flags_default = { .spacing = 1 };

struct photon_settings photon_settings_default(void)
{
    return (struct photon_settings){ .gather = { 20, 100 },
                                     .radius_share = 1,
                                     .step = 1,
                                     .media_radius_share = 1,
                                     .jitter = 0.4 };
}
