/** One experiment: a scenario under a detection model and a policy, repeated over seeds. */
package org.hificamsim.runs;
