/// A warning without the "road.toml:31: warning: " of the command line, which is redundant where warnings are listed.
export const bareWarning = (text: string) => text.replace(/^(?:.*?: )?warning: /, '');
