/** Finds detection models, policies, movements and listeners by name, with their options. */
package org.hificamsim.core.registry;
