/** The step: one short loop for every scenario, detection model and policy. */
@StableApi(since = "0.1")
package org.hificamsim.core.engine;

import org.hificamsim.core.StableApi;
