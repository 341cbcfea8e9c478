/** Light colours, dark ones, or those of the system. */
export function showInColours(scheme: string): void {
  localStorage.setItem("colours", scheme);
  document.documentElement.style.colorScheme = scheme;
}
