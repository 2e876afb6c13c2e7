package badlog.core.text

/** Returns whether [char] is a letter of any script. Uses the platform's own tables if it has them, to avoid shipping any. */
public expect fun isLetter(char: Char): Boolean

/** Returns whether [char] is a letter or a digit of any script. */
public expect fun isLetterOrDigit(char: Char): Boolean
