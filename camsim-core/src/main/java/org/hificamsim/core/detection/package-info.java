/** Target detection: how sure a camera is of a target, and which distances that lets it detect. */
@StableApi(since = "0.1")
package org.hificamsim.core.detection;

import org.hificamsim.core.StableApi;
