package badlog.viewer.text

/**
 * Returns [name] in characters that an address never changes or uses as separators. These are letters and digits, `-_./`, `+` for a space,
 * and `~` with four hexadecimal digits for any other character.
 */
fun addressText(name: String): String = buildString {
    for (char in name) {
        when {
            char in 'a'..'z' || char in 'A'..'Z' || char in '0'..'9' || char in PLAIN -> append(char)
            char == ' ' -> append('+')
            else -> append('~').append(char.code.toString(HEXADECIMAL).padStart(DIGITS, '0'))
        }
    }
}

/** Returns the name that [addressText] wrote as [text]; null if a `~` is not followed by four hexadecimal digits. */
fun nameOfAddress(text: String): String? {
    val name = StringBuilder()
    var at = 0
    while (at < text.length) {
        val char = text[at++]
        if (char == '~') {
            val digits = text.substring(at, minOf(at + DIGITS, text.length))
            if (digits.length < DIGITS || digits.any { it !in '0'..'9' && it !in 'a'..'f' && it !in 'A'..'F' }) return null
            name.append(digits.toInt(HEXADECIMAL).toChar())
            at += DIGITS
        } else {
            name.append(if (char == '+') ' ' else char)
        }
    }
    return name.toString()
}

private const val PLAIN = "-_./"
private const val HEXADECIMAL = 16
private const val DIGITS = 4
