/** What the elements of a scenario file say: cameras, lenses, targets, zones, events. */
@StableApi(since = "0.2")
package org.hificamsim.core.scenario.spec;

import org.hificamsim.core.StableApi;
