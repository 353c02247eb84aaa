/** The sensitivity of the conclusion of chapter 8 to each open parameter. */
package org.hificamsim.reproduction.sensitivity;
