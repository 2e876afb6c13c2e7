package badlog.core.text

import kotlin.js.RegExp

public actual fun isLetter(char: Char): Boolean =
    if (char.code < ASCII_END) char in 'a'..'z' || char in 'A'..'Z' else LETTER.test(char.toString())

public actual fun isLetterOrDigit(char: Char): Boolean =
    isLetter(char) || char in '0'..'9' || (char.code >= ASCII_END && DIGIT.test(char.toString()))

private val LETTER = RegExp("\\p{L}", "u")
private val DIGIT = RegExp("\\p{Nd}", "u")
private const val ASCII_END = 128
