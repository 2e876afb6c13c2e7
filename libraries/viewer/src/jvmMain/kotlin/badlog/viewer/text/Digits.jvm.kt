package badlog.viewer.text

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode

internal actual fun fixedDigits(value: Double, decimals: Int): String =
    BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString()

internal actual fun exponentialDigits(value: Double, decimals: Int): String {
    val rounded = BigDecimal(value).round(MathContext(decimals + 1, RoundingMode.HALF_UP))
    val exponent = if (rounded.signum() == 0) 0 else rounded.precision() - rounded.scale() - 1
    return "${rounded.movePointLeft(exponent).setScale(decimals, RoundingMode.HALF_UP).toPlainString()}e$exponent"
}
