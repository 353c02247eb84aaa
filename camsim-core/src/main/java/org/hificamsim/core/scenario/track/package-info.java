/** The recorded way of a target: its samples, and where it is at each step. */
@StableApi(since = "0.2")
package org.hificamsim.core.scenario.track;

import org.hificamsim.core.StableApi;
