/** What a camera sees of a target: the pipeline of reach, angle, confidence and rule. */
@StableApi(since = "0.1")
package org.hificamsim.core.visibility;

import org.hificamsim.core.StableApi;
