/** The elements of a scenario file as records: cameras, lenses, targets, zones, events. */
@StableApi(since = "0.2")
package org.hificamsim.core.scenario.spec;

import org.hificamsim.core.StableApi;
