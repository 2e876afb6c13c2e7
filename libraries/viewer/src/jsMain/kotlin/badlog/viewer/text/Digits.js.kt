package badlog.viewer.text

internal actual fun fixedDigits(value: Double, decimals: Int): String {
    val text = value.asDynamic().toFixed(decimals).unsafeCast<String>()
    // JavaScript may round to a negative zero.
    return if (value < 0 && text.asDynamic() == 0) text.substring(1) else text
}

internal actual fun exponentialDigits(value: Double, decimals: Int): String =
    value.asDynamic().toExponential(decimals).unsafeCast<String>().replace("+", "")
