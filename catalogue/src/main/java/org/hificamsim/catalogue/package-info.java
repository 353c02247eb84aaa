/** All detection models, policies, movements and listeners, wired together in one place. */
package org.hificamsim.catalogue;
