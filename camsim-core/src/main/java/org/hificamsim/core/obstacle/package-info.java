/** Obstacles between cameras and targets, and what is visible past them. */
@StableApi(since = "0.1")
package org.hificamsim.core.obstacle;

import org.hificamsim.core.StableApi;
