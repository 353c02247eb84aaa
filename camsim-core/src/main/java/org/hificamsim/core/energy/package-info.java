/** The energy that cameras use in the parts of a step, and their batteries. */
@StableApi(since = "0.2")
package org.hificamsim.core.energy;

import org.hificamsim.core.StableApi;
