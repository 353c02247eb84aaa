/** Programs that run in processes of their own, with limits. */
package org.hificamsim.core.program;
