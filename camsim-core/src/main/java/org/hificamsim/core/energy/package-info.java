/** What cameras take for the parts of a step, and what their batteries hold. */
@StableApi(since = "0.2")
package org.hificamsim.core.energy;

import org.hificamsim.core.StableApi;
