package badlog.core.text

public actual fun isLetter(char: Char): Boolean = Character.isLetter(char)

public actual fun isLetterOrDigit(char: Char): Boolean = Character.isLetterOrDigit(char)
