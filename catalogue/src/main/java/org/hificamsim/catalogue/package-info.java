/** All detection models, policies, movements and listeners, wired together in one place. */
@StableApi(since = "0.1")
package org.hificamsim.catalogue;

import org.hificamsim.core.StableApi;
