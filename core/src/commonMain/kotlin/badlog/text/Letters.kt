package badlog.text

/** Whether [char] is a letter of any script. Where the platform knows that by itself, no table has to be carried. */
public expect fun isLetter(char: Char): Boolean

/** Whether [char] is a letter or a digit of any script. */
public expect fun isLetterOrDigit(char: Char): Boolean
