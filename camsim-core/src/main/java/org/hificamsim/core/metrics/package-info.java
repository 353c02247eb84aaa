/** Coverage metrics of a step and of a run (thesis 7.1). */
@StableApi(since = "0.1")
package org.hificamsim.core.metrics;

import org.hificamsim.core.StableApi;
