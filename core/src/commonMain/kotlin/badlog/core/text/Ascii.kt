package badlog.core.text

// The bytes with a special meaning in a bag.
internal const val NUL = 0
internal const val TAB = 9
internal const val LF = 10
internal const val CR = 13
internal const val SPACE = 32
internal const val QUOTE = 34
internal const val COMMA = 44
internal const val PLUS = 43
internal const val MINUS = 45
internal const val DOT = 46
internal const val ZERO = 48
internal const val NINE = 57
internal const val BRACE = 123
