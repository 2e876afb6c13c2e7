package badlog.page

/** The screen of a page. */
internal data class Screen(
    val width: Int,
    val height: Int,
    val density: Double = 1.0,
    val isPhone: Boolean = false,
    val isDark: Boolean = false,
) {
    companion object {
        val WIDE: Screen = Screen(1280, 900)
        val PHONE: Screen = Screen(390, 844, density = 2.0, isPhone = true)
    }
}
