/** The state of a running scenario: cameras and targets in flat arrays, and what changes them. */
@StableApi(since = "0.1")
package org.hificamsim.core.world;

import org.hificamsim.core.StableApi;
