/** Whether a camera sees a target: the pipeline of reach, angle, confidence and rule. */
@StableApi(since = "0.1")
package org.hificamsim.core.visibility;

import org.hificamsim.core.StableApi;
