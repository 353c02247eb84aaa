/** Zoom policies: what a camera agent decides from, and the interface that it implements. */
@StableApi(since = "0.1")
package org.hificamsim.core.policy;

import org.hificamsim.core.StableApi;
