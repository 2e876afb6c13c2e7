package badlog.cli.console

import java.nio.charset.Charset

/** Spells texts with the characters of [charset], so that different names never become the same question marks. */
internal class Spelling(charset: Charset) {
    private val encoder = charset.newEncoder()
    private val hasAll = charset == Charsets.UTF_8

    /** Returns [text] with simpler characters in place of those that [charset] lacks. Letters become codes, such as `\u00f6`. */
    fun of(text: String): String {
        // Only unpaired surrogates are not in Unicode.
        if ((hasAll && text.none { it.isSurrogate() }) || encoder.canEncode(text)) return text
        return buildString {
            for (char in text) if (char.isSurrogate() || !encoder.canEncode(char)) append(SIMPLER[char] ?: escaped(char)) else append(char)
        }
    }

    companion object {
        private val SIMPLER = mapOf(
            '“' to "\"", '”' to "\"", '‘' to "'", '’' to "'", '…' to "...", '–' to "-", '—' to "-", '−' to "-", '×' to "x", 'µ' to "u",
            'μ' to "u",
            '°' to " deg ", '²' to "^2", '³' to "^3", '·' to "*", '≤' to "<=", '≥' to ">=", '≠' to "!=", '\u00A0' to " ", '\u202F' to " ",
            '\uFFFD' to "?", 'Ω' to "ohm", '\u2126' to "ohm", '±' to "+-", '→' to "->", '≈' to "~", '½' to "1/2", '✓' to "+",
        )

        /** Returns the same [json] in plain ASCII, which works with any encoding of the standard output. */
        fun ascii(json: String): String {
            if (json.all { it.code < ASCII }) return json
            return buildString {
                for (char in json) if (char.code < ASCII) append(char) else append(escaped(char))
            }
        }

        private const val ASCII = 0x7F

        /** Returns [char] escaped as in JSON and programs. */
        fun escaped(char: Char): String = "\\u" + char.code.toString(16).padStart(4, '0')
    }
}
