/**
 * Target detection: how confident a camera is of a target, and at which distances it detects one.
 */
@StableApi(since = "0.1")
package org.hificamsim.core.detection;

import org.hificamsim.core.StableApi;
