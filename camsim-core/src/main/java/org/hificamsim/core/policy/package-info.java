/** Zoom policies: what a camera agent decides from, and the interface that it implements. */
package org.hificamsim.core.policy;
