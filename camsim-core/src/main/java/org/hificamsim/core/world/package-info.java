/** The world's state in flat arrays: field, cameras, targets, and how they change. */
@StableApi(since = "0.1")
package org.hificamsim.core.world;

import org.hificamsim.core.StableApi;
