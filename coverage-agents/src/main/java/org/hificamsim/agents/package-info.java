/** The zoom policies of chapter 7, registered by name. */
@StableApi(since = "0.1")
package org.hificamsim.agents;

import org.hificamsim.core.StableApi;
