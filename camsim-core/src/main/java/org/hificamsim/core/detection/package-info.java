/** Target detection: how sure a camera is of a target, and which distances that lets it detect. */
package org.hificamsim.core.detection;
