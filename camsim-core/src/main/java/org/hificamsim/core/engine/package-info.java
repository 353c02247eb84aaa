/** The step: one short loop for every scenario, detection model and policy. */
package org.hificamsim.core.engine;
