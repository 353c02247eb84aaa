/** Finds detection models, policies, movements and listeners by name, with their options. */
@StableApi(since = "0.1")
package org.hificamsim.core.registry;

import org.hificamsim.core.StableApi;
