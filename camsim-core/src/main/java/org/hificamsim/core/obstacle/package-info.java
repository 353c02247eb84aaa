/** What stands between a camera and a target, and what a camera sees past it. */
@StableApi(since = "0.1")
package org.hificamsim.core.obstacle;

import org.hificamsim.core.StableApi;
